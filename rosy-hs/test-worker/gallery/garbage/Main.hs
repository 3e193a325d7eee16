?? hello robot, please drive ;-)
