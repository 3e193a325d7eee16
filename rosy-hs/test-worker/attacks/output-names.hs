{-# LANGUAGE UnicodeSyntax #-}
main = simulate (ﬀ, ｈarm)

ﬀ :: Velocity -> Maybe Sound
ﬀ _ = Nothing

ｈarm :: Velocity -> Maybe Sound
ｈarm _ = Nothing
