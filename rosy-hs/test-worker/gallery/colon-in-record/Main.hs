data Robo = Robo { speed :: Double }
go :: Bumper -> Memory Robo
go _ = Memory (Robo { speed : 3 })
main = simulate go
