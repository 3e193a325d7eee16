{-# LANGUAGE DerivingVia, StandaloneDeriving #-}
newtype Hidden = Hidden (IO String)

deriving via (IO String) instance Show Hidden

main = simulate (Say (show (Hidden (readFile "CANARY"))))
