data Heap = Heap

instance Show Heap where
  show h = show h

main = simulate keep

keep :: Velocity -> Memory Heap
keep _ = Memory Heap
