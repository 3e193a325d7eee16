data Ping = Ping
data Pong = Pong

main = simulate (start, ping, pong)

start :: Velocity -> Ping
start _ = Ping

ping :: Ping -> [Pong]
ping _ = [Pong, Pong]

pong :: Pong -> [Ping]
pong _ = [Ping, Ping]
