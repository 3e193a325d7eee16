-- Operators of one's own, in front, between, and with bindings.
infixl 6 |+|
infixl 7 `scale`
infixl 1 ~>
infix 4 `near`, =~=

data V = V Double Double

(|+|) :: V -> V -> V
V a b |+| V c d = V (a + c) (b + d)

scale :: Double -> V -> V
k `scale` V a b = V (k * a) (k * b)

near, (=~=) :: V -> V -> Bool
V a b `near` V c d = abs (a - c) < 0.1 && abs (b - d) < 0.1
(=~=) v w = v `near` w

(~>) :: a -> (a -> b) -> b
x ~> f = f x

(!) :: [a] -> Int -> a
(x : _) ! 0 = x
(_ : xs) ! n = xs ! (n - 1)
[] ! _ = error "no such item"

compose3 :: (c -> d) -> (b -> c) -> (a -> b) -> a -> d
(f `compose3` g) h = f . g . h

mixed :: V
mixed = 2 `scale` V 1 0 |+| 3 `scale` V 0 1 |+| V 1 1

asks :: V -> Bool
asks v = not $ v |+| V 0 0 =~= V 1 1 || v `near` V 0 0 && True

local :: Int
local = 1 <+> 2 <+> 3
  where
    infixr 5 <+>
    a <+> b = a - b

prefix :: Int
prefix = (+) 1 ((*) 2 3) + (`div` 2) 9 + (!) [1, 2] 1

flow :: Double
flow = [1, 2, 3] ~> map (+ 1) ~> sum

main = simulate (Velocity flow 0)
