data Robo = Robo { speed :: Double }
go :: Memory Robo -> Velocity
go (Memory r) = Velocity r.speed 0
main = simulate go
