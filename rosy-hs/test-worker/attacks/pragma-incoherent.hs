{-# LANGUAGE IncoherentInstances, ImpredicativeTypes, UndecidableSuperClasses #-}
class Second a => First a

class First a => Second a

instance {-# INCOHERENT #-} Show a where
  show _ = "HARM"

main = simulate (Velocity 0 0)
