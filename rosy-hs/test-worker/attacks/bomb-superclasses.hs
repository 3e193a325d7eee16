class C0 a

class (C0 a) => C1 a

class (C0 a, C1 a) => C2 a

class (C0 a, C1 a, C2 a) => C3 a

class (C0 a, C1 a, C2 a, C3 a) => C4 a

class (C0 a, C1 a, C2 a, C3 a, C4 a) => C5 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a) => C6 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a) => C7 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a) => C8 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a) => C9 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a) => C10 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a) => C11 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a) => C12 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a) => C13 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a) => C14 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a) => C15 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a) => C16 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a) => C17 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a) => C18 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a, C18 a) => C19 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a, C18 a, C19 a) => C20 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a, C18 a, C19 a, C20 a) => C21 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a, C18 a, C19 a, C20 a, C21 a) => C22 a

class (C0 a, C1 a, C2 a, C3 a, C4 a, C5 a, C6 a, C7 a, C8 a, C9 a, C10 a, C11 a, C12 a, C13 a, C14 a, C15 a, C16 a, C17 a, C18 a, C19 a, C20 a, C21 a, C22 a) => C23 a

f :: C23 a => a -> Say
f _ = Say "made"

main = simulate (Say "made")
