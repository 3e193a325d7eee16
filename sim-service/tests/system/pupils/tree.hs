data Tree a = Leaf | Node (Tree a) a (Tree a)
instance Foldable Tree where
  foldr _ z Leaf = z
  foldr f z (Node l x r) = foldr f (f x (foldr f z r)) l
insertT :: Ord a => a -> Tree a -> Tree a
insertT x Leaf = Node Leaf x Leaf
insertT x t@(Node l y r) = case compare x y of { LT -> Node (insertT x l) y r; GT -> Node l y (insertT x r); EQ -> t }
collect :: () -> StdGen -> Memory (Tree Int) -> (Memory (Tree Int), Maybe Say)
collect () g (Memory t) = (Memory t', if length t' == 5 && length t < 5 then Just (Say (show (sum t' > 0, maximum t' <= 9))) else Nothing)
  where t' = insertT (fst (randomR (0, 9) g)) t
main = simulate collect
