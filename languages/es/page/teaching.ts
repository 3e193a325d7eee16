/// What the pages for teachers say besides the lessons' own texts, in Spanish.

import type {TeachingWords} from "../../en/page/teaching.ts"

export const teaching: TeachingWords = {
  labels: {
    about: (minutes, week) => `Unos ${minutes} minutos · semana ${week}`,
    optional: (minutes, week) => `Unos ${minutes} minutos · opcional, desde la semana ${week}`,
    aims: "Lo que los alumnos saben después",
    steps: "Lo que se pide",
    step: "paso",
    rightAnswer: "respuesta correcta, o lo que se comprueba",
    begins: "La lección empieza con este programa",
    ask: "Preguntas que puedes hacer",
    wrong: "Lo que sale mal",
    nearMisses:
      "Algunos intentos que no pasan, con las líneas que importan y lo que dice de ellos la página:",
    says: (check, seen) => `«${check}» no está hecho. ${seen}`,
    solutions: "Soluciones que pasan",
    others: "También pasan estas:",
  },
  plan: {
    title: "Doce semanas",
    lead: "Un plan para un trimestre con una clase de 45 minutos por semana. Los alumnos hacen las lecciones de la página solos o por parejas; el resto del tiempo es para hablar, para el papel y para los proyectos. Con dos clases por semana, la segunda es para un proyecto.",
    columns: ["semana", "lecciones", "de qué trata", "preparar", "juntos y en papel"],
    handbook: "45 minutos juntos",
    weeks: [
      "Iniciar la clase; tres palabras para cada alumno. Imprimir la ficha.",
      "Una caja o una mochila en el suelo, para dar vueltas alrededor.",
      "Un metro de cinta en el suelo.",
      "Nada; los alumnos dan palmadas.",
      "El proyector, para **¿Por qué?**.",
      "Un juguete que se pueda levantar, si lo hay. Elegir los proyectos.",
      "Prueba 1 en papel, 20 minutos. Una nota y un lápiz como «memoria».",
      "Tres tarjetas: Go, Back, Turn.",
      "Un dado por pareja.",
      "Una receta de cocina.",
      "Dos alumnos que hacen cosas al mismo tiempo.",
      "Prueba 2, el concurso, y se enseñan los proyectos.",
    ],
    strand: (page, week) =>
      `**Con matemáticas:** desde la semana ${week} se puede añadir la serie [Álgebra](${page}), también en clase de matemáticas:`,
    after: projects =>
      `**Si falta tiempo:** deja fuera la tercera lección de las semanas 6, 8, 9 y 11. **Si la clase va rápido:** empieza los [proyectos](${projects}) en la semana 5. Una lección sin terminar se abre la próxima vez en el mismo paso.`,
  },
  curricula: {
    title: "Lo que la escuela debe enseñar",
    lead: "Frases de los currículos, tal como están escritas y en su lengua, y las lecciones de la página en las que los alumnos hacen lo que piden. *En parte* quiere decir que las lecciones no lo enseñan todo. Aquí solo está lo que se pudo citar, y la elección de las lecciones es nuestra: ninguna autoridad la ha revisado. Los currículos cambian: compara cada frase con la edición vigente antes de apoyarte en ella.",
    columns: ["dónde", "frase", "lecciones"],
    part: "en parte",
    all: "todas las lecciones",
    incomplete: "Lo que este documento dice de la programación en cada curso no se pudo citar; falta aquí.",
    places: {
      csta: "Estados Unidos",
      england: "Inglaterra",
      kmk: "Alemania",
      "baden-7": "Alemania: Baden-Wurtemberg, 7.º curso",
      baden: "Alemania: Baden-Wurtemberg, Gymnasium",
      "cycle-4": "Francia: cursos 7.º a 9.º (cycle 4)",
      snt: "Francia: 10.º curso (seconde)",
      spain: "España",
      portugal: "Portugal",
    },
  },
  lessons: {
    "hello-robot": {
      often: "Los alumnos esperan el final del programa. No lo hay: una velocidad vale hasta que llega otra.",
      ask: [
        "¿Dónde está después de 10 segundos?",
        "¿Cuándo se para?",
        "¿Qué número cambias para llegar el doble de lejos?",
      ],
    },
    "turn-on-the-spot": {
      often: "El segundo número se lee como grados. Son radianes por segundo: 3,14 es media vuelta.",
      ask: [
        "¿La izquierda es la tuya o la del robot?",
        "¿Cuánto tarda una vuelta entera con 0,5?",
        "¿Qué hace un menos?",
      ],
    },
    "round-the-box": {
      often:
        "Los alumnos esperan una esquina: primero recto y luego el giro. Los dos números valen a la vez.",
      ask: [
        "¿Qué hace más grande el círculo?",
        "Dos pares de números, el mismo círculo: ¿cuáles?",
        "¿Qué círculo sale con 0 como segundo número?",
      ],
    },
    "light-and-motion": {
      often: "El segundo valor se toma por un segundo paso. Uno al lado del otro quiere decir a la vez.",
      ask: [
        "¿Importa el orden?",
        "¿Qué hace un programa con dos velocidades?",
        "¿Qué puedes hacer tú a la vez?",
      ],
    },
    faster: {
      often: "`vl + 0.02` parece una velocidad de 0,02. Es lo que se suma, 50 veces por segundo.",
      ask: ["¿Qué recibe la función y qué da?", "¿Cuántas veces se le pregunta?", "¿Qué haría `vl - 0.02`?"],
    },
    "stop-in-time": {
      often: "Se cree que se elige una vez, al principio. Se elige de nuevo con cada informe.",
      ask: [
        "¿Cuánto es `x` ahora, y ahora?",
        "¿Qué pasa si llevas el robot hacia atrás?",
        "¿Por qué no `x == 2`?",
      ],
    },
    bump: {
      often: "Un choque son dos eventos, pulsado y suelto; por eso hay dos sonidos.",
      ask: [
        "¿Cuántos eventos ha habido?",
        "¿Qué envía `Nothing`?",
        "¿En qué se diferencian `Nothing` y una luz apagada?",
      ],
    },
    "which-side": {
      often: "Un caso en el que encaja todo está el primero, y los otros no se usan nunca.",
      ask: ["¿Qué caso encaja con este evento?", "¿Y si encajan dos casos?", "¿Qué significa `_` aquí?"],
    },
    "two-wills": {
      often:
        "Los alumnos cambian el orden de las funciones: dicen que gana la última. Lo que cuenta es quién envía el último.",
      ask: [
        "¿Quién ha enviado lo que hace ahora el robot?",
        "¿Cuántas veces envía cada una?",
        "¿Cómo decidirías entre dos amigos que te dan órdenes?",
      ],
    },
    "remote-control": {
      often: "Se espera que el robot pare al soltar el botón. Nadie se lo ha dicho.",
      ask: [
        "¿Qué evento es soltar?",
        "¿Cómo sería un mando que solo avanza mientras pulsas?",
        "¿Qué hace el robot sin ningún comando?",
      ],
    },
    "one-or-the-other": {
      often: "`Either` se lee como «cuando han pasado las dos cosas». Responde a cada una cuando llega.",
      ask: [
        "¿Cuál de las dos ha sido?",
        "¿En qué nota la función la diferencia?",
        "¿Qué cambiaría con dos funciones?",
      ],
    },
    "lift-me": {
      often: "En el aire solo cambia la luz. Las ruedas necesitan un comando propio.",
      ask: [
        "¿Qué no debe pasar nunca?",
        "¿Quién puede volver a encender las ruedas?",
        "¿Qué máquinas de tu casa se paran cuando se abren?",
      ],
    },
    "wire-a-reflex": {
      often:
        "Se espera que gane el segundo cable al mismo actuador. Los dos envían; algo debe decir cuál va primero.",
      ask: [
        "¿Qué sensores llegan a las ruedas?",
        "¿Qué está en el diagrama, y qué solo en la función?",
        "¿Dónde empezaría un tercer cable a `Velocity`, y quién debería ir primero entonces?",
      ],
    },
    "stop-before-the-wall": {
      often:
        "Se confunde la distancia libre delante con el camino recorrido. Una disminuye y el otro aumenta.",
      ask: [
        "¿Hacia dónde va el número?",
        "¿Y si la pared se mueve?",
        "¿Cómo pararías a 10 cm de una pared, empiece donde empiece?",
      ],
    },
    "count-the-bumps": {
      often:
        "Se cuenta también al soltar, o se espera el número nuevo enseguida. La función lee el valor viejo y envía el nuevo.",
      ask: [
        "¿Qué hay en la memoria antes del primer choque?",
        "¿Qué lee en el tercer choque?",
        "¿Por qué dice 2, 4, 6?",
      ],
    },
    "there-and-back": {
      often: "Se espera que `bump` dé la vuelta por sí mismo. Solo escribe; `drive` tiene que leer.",
      ask: ["¿Quién escribe y quién lee?", "¿Se conocen?", "¿Qué hace `drive` antes de que se escriba algo?"],
    },
    "a-mode-of-my-own": {
      often: "Se añade un caso al tipo, y una de las funciones no lo conoce.",
      ask: [
        "¿En qué sitios aparece cada modo?",
        "Dibuja los modos como círculos: ¿qué flechas hay?",
        "¿`Mode` es un valor o una lista de valores?",
      ],
    },
    "for-one-second": {
      often: "Los alumnos buscan un comando que espere. Nada espera; el reloj se compara una y otra vez.",
      ask: [
        "¿Qué se recuerda: una hora o una duración?",
        "¿Qué pasa con un choque durante ese segundo?",
        "¿Cómo lo harías de medio segundo?",
      ],
    },
    "three-states": {
      often: "El estado se busca en una función. Está en la memoria; las funciones la leen y la escriben.",
      ask: [
        "¿Qué flecha le falta a la máquina?",
        "Dibuja los tres estados como círculos: ¿qué sensor está en qué flecha?",
        "¿Qué hace el botón en `Go`?",
      ],
    },
    "my-own-event": {
      often:
        "La respuesta se escribe dos veces, una por sensor. Un evento con dos emisores necesita una respuesta.",
      ask: [
        "¿Quién envía `Blocked` y quién lo acepta?",
        "¿Qué cambia con un tercer sensor?",
        "¿Cómo se llama tu evento?",
      ],
    },
    chance: {
      often:
        "Se espera que el azar sea distinto cada vez. La misma semilla da la misma ejecución, y así se puede volver a mirar.",
      ask: [
        "¿Por qué es bueno poder repetir una ejecución?",
        "¿Qué hace la función con el generador que recibe de vuelta?",
        "¿En qué sala es mejor una regla fija?",
      ],
    },
    "a-recipe": {
      often: "Se escriben metros donde van centímetros: `drive 1` es un centímetro.",
      ask: [
        "¿Cuándo empieza el segundo paso?",
        "¿Cuándo termina el programa?",
        "¿En qué se diferencia de dos funciones una al lado de la otra?",
      ],
    },
    "four-times": {
      often:
        "Los pasos se copian cuatro veces y se cambia una copia. Una pieza con nombre se cambia en un solo sitio.",
      ask: ["¿Qué se repite?", "¿Cuánto gira en total?", "¿Qué ángulo hace un triángulo?"],
    },
    "look-inside": {
      often: "Se espera que `Done` pare el robot. Termina la tarea; la última velocidad sigue valiendo.",
      ask: [
        "¿Qué empieza, qué vigila, qué termina?",
        "¿Quién para las ruedas?",
        "¿Qué no enviaría nunca `Done`?",
      ],
    },
    "a-task-that-answers": {
      often: "Dice el texto «distance» en vez del número, o metros en vez de centímetros.",
      ask: [
        "¿De dónde viene el resultado?",
        "¿Puede cambiar después?",
        "¿Cómo obtendrías el área de la sala?",
      ],
    },
    "at-the-same-time": {
      often: "Se usa `parallel` donde una debe rendirse: espera a las dos.",
      ask: [
        "¿Cuál de las dos termina primero?",
        "¿Qué le pasa a la otra?",
        "¿Cuándo quieres la primera y cuándo las dos?",
      ],
    },
    "the-papers-robot": {
      often:
        "La seguridad y la curiosidad envían a las ruedas a la vez. Lo que más importa debe frenar a lo otro.",
      ask: ["¿Qué debe ganar siempre?", "¿Durante cuánto tiempo?", "Prueba otra sala: ¿qué fue suerte?"],
    },
    "a-machine-for-numbers": {
      often: "Toman la letra por un solo número. `x` es cada lugar del camino, uno tras otro.",
      ask: [
        "¿Qué salida corresponde a la entrada 2?",
        "¿Qué entrada da 0?",
        "¿Pueden dos entradas tener la misma salida? ¿Puede una tener dos?",
      ],
    },
    "where-the-graph-meets-zero": {
      often:
        "Toman la gráfica por el camino del robot. A la derecha está el lugar, arriba la velocidad; el camino está en la sala.",
      ask: [
        "¿Qué ecuación ha resuelto el robot?",
        "¿Qué hace una gráfica más empinada?",
        "Lleva el robot más allá del cero: ¿adónde va?",
      ],
    },
    "a-graph-in-pieces": {
      often:
        "Leen las condiciones como si cada una estuviera sola. `x < 2` también vale en 0,5; allí no cuenta, porque encaja un caso anterior.",
      ask: [
        "¿Para qué `x` vale cada regla?",
        "¿Dónde se unen dos trozos y dónde hay un salto?",
        "¿Hay una entrada sin salida?",
      ],
    },
    "machines-in-a-row": {
      often:
        "Leen `speed . distance` desde la izquierda. La máquina de la derecha trabaja primero: `speed (distance here)`, como en f(g(x)).",
      ask: [
        "¿Qué pasa de una máquina a la otra?",
        "¿Se pueden cambiar de orden? ¿Qué dicen sus tipos?",
        "¿Qué máquina cambia si se mueve el anillo?",
      ],
    },
    "a-family-of-functions": {
      often:
        "`a` y `x` son letras y se confunden. `x` cambia mientras el robot se mueve; `a` se elige una vez y se queda.",
      ask: [
        "¿Qué tienen en común todas las de la familia?",
        "¿Qué pasa con `a` negativo?",
        "¿Qué letra es la entrada y cuáles son parámetros?",
      ],
    },
    "rate-of-change": {
      often:
        "Leen posición y velocidad en la misma curva. Una posición horizontal es velocidad 0; una velocidad horizontal, una posición que sube por igual.",
      ask: [
        "¿Cómo se ve en la posición cuándo iba más rápido?",
        "¿Qué significa una posición que baja?",
        "¿Qué dice el área bajo la velocidad?",
      ],
    },
  },
}
