{-# LANGUAGE DataKinds #-}
import Data.Proxy
import GHC.TypeLits

main = simulate (Say (show (natVal (Proxy :: Proxy (2 ^ (2 ^ (2 ^ (2 ^ 5))))))))
