"""
Accounting of what clients use: who a client is, what each resource grants to one, and the queues and slots that decide.

``resources`` is the only place with such numbers; everything that costs places, computing or connections asks it.
"""
