data V2 = V2 Double Double

infixl 6 |+|
infixl 7 *|

(|+|) :: V2 -> V2 -> V2
V2 a b |+| V2 c d = V2 (a + c) (b + d)

(*|) :: Double -> V2 -> V2
k *| V2 a b = V2 (k * a) (k * b)

dot :: V2 -> V2 -> Double
V2 a b `dot` V2 c d = a * c + b * d

home :: V2
home = V2 1 2 |+| 0.5 *| V2 3 4 |+| V2 0 0

main = simulate (Say (show (home `dot` home)))
