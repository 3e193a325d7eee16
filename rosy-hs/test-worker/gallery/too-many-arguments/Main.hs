main = simulate stop

stop :: Bumper -> Velocity
stop b = halt b

halt :: Velocity
halt = Velocity 0 0
