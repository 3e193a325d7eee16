{-# LANGUAGE TemplateHaskell #-}
import Language.Haskell.TH

main = simulate (Say $(runIO (readFile "CANARY") >>= litE . stringL))
