{-# LANGUAGE PolyKinds, DataKinds, KindSignatures #-}
import Data.Proxy

main = simulate (Say (show p9))

p0 = Proxy :: Proxy '[ 'True ]
p1 = pair p0 p0
p2 = pair p1 p1
p3 = pair p2 p2
p4 = pair p3 p3
p5 = pair p4 p4
p6 = pair p5 p5
p7 = pair p6 p6
p8 = pair p7 p7
p9 = pair p8 p8

pair :: Proxy a -> Proxy b -> Proxy '(a, b)
pair _ _ = Proxy
