import GHC.Generics

data Forged = Forged (IO String)

instance Generic Forged where
  type Rep Forged = K1 R String
  from _ = K1 "HARM"
  to _ = Forged (readFile "CANARY")

main = simulate (Say "no")
