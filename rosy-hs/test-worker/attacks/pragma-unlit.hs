\begin{code}
main = simulate (Velocity 0 0)
\end{code}
