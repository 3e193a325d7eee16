{-# LANGUAGE UnicodeSyntax #-}

import Control.Monad (forM_)

twice ∷ (a → a) → a → a
twice f x = f (f x)

shown ∷ Show a ⇒ a → String
shown x = show x ++ "→"

faster ∷ Velocity → Velocity
faster (Velocity v w) = Velocity (twice (\x → x * 1.1) v) w

name ∷ Maybe Int → String
name m = case m of
  Just n → shown n
  Nothing → ""

walk ∷ Task ()
walk = do
  forM_ [1 .. 4 ∷ Int] (\_ → drive 20)

main = simulate faster
