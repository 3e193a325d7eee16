infixl 6 ⊕

-- Adds two velocities.
(⊕) :: Velocity -> Velocity -> Velocity
Velocity a b ⊕ Velocity c d = Velocity (a + c) (b + d)

(★) :: Double -> Double -> Double
a ★ b = a * b

x → y = x ++ y

half, whole :: Double
half = 1 ÷ 2 where a ÷ b = a / b
whole = half ★ 2

data Way = Way :⇄ Way | Stop

slow :: Velocity -> Velocity
slow v = v ⊕ Velocity (negate 0.1 ★ 1) 0

greet :: Bumper -> Say
greet _ = Say ("a" → "→")

main = simulate (slow, greet)
