main=simulate(go,stop)
go::Bumper->Velocity
go(Bumper _ Pressed)=Velocity 0 0;go _=Velocity 0.3 0
stop=Led1 Red
