plugins { `java-library` }

// The root project's own sources are src/test: the integration tests that span the modules.
allprojects { apply(plugin = "java-library") }

allprojects {
    val isApi = name == "dfra-api"
    tasks.withType<JavaCompile>().configureEach {
        options.release.set(17)
        options.encoding = "UTF-8"
        // Else each place that joins strings is linked when it first runs, again in every process that starts.
        options.compilerArgs.addAll(
            listOf("-Xlint:all,-serial,-removal,-processing,-options", "-XDstringConcat=inline"))
        // Of main sources, only the API's names are printed (./dfra module call).
        if (isApi || name != "compileJava") options.compilerArgs.add("-parameters")
    }
    // A broken link or bad HTML in a comment is an error; as in pom.xml, not in the comments of tests.
    tasks.named<JavaCompile>("compileJava") { options.compilerArgs.add("-Xdoclint:all,-missing") }
    // Without tables of local variables, which only a debugger shows: a robot's jars are smaller.
    tasks.named<JavaCompile>("compileJava") { options.debugOptions.debugLevel = "lines,source" }
    // Jar names carry no version, in either build: class paths and codebases name them.
    // And the same sources give the same bytes, as pom.xml's outputTimestamp has it.
    tasks.withType<Jar>().configureEach {
        archiveVersion.set("")
        manifest { attributes("Implementation-Version" to project.version) } // "./dfra --version" reads it
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
    }

    dependencies {
        "compileOnly"(rootProject.libs.jspecify)
        "testCompileOnly"(rootProject.libs.jspecify)
        "compileOnly"(rootProject.libs.error.prone.annotations)
        "testCompileOnly"(rootProject.libs.error.prone.annotations)
        "testImplementation"(rootProject.libs.junit.jupiter)
        "testImplementation"(rootProject.libs.assertj.core)
        "testImplementation"(rootProject.libs.awaitility)
        "testRuntimeOnly"("org.junit.platform:junit-platform-launcher")
    }

    // java.rmi.activation left the JDK in 17; JERI needs it, and only the boot loader may define it.
    // The configuration cache keeps what this lambda captures: a provider and a string, no task and no project.
    val activationJar = project(":dfra-activation").tasks.named<Jar>("jar")
    val bootJar = activationJar.flatMap { it.archiveFile }
    val top = rootDir.path
    val dfraArguments = {
        val boot = bootJar.get().asFile.path
        listOf("-Xbootclasspath/a:$boot", "-Ddfra.boot-class-path=$boot", "-Ddfra.root=$top")
    }
    val full = providers.gradleProperty("dfra.full").getOrElse("false")
    val soak = providers.gradleProperty("dfra.soak").getOrElse("false")
    val repeats = providers.gradleProperty("dfra.test.repeats").getOrElse("false")
    val seed = providers.gradleProperty("dfra.seed").getOrElse("2004") // as in pom.xml
    val testJava = providers.gradleProperty("dfra.test.java").orNull
    tasks.withType<Test>().configureEach {
        group = "dfra"
        dependsOn(activationJar)
        useJUnitPlatform()
        include("**/*Test.class", "**/*IT.class")
        // Much of a test's time is waiting, for leases, devices and processes; src/test loads the computer by itself.
        maxParallelForks = if (project == rootProject) 1 else 2
        // The full counts of the modules' own tests are worth the slower compiler; nothing else lives as long.
        val compiler = if (full == "true" && project != rootProject) 4 else 1
        jvmArgs("-Xshare:auto", "-XX:TieredStopAtLevel=$compiler", "-XX:+UseSerialGC")
        jvmArgumentProviders.add(CommandLineArgumentProvider(dfraArguments))
        systemProperty("dfra.full", full)
        systemProperty("dfra.soak", soak)
        systemProperty("dfra.test.repeats-overloaded", repeats)
        systemProperty("dfra.seed", seed)
        if (testJava != null) executable("$testJava/bin/java")
        outputs.upToDateWhen { false } // they start processes and watch clocks: a result of yesterday proves little
    }
    tasks.withType<JavaExec>().configureEach {
        dependsOn(activationJar)
        jvmArgumentProviders.add(CommandLineArgumentProvider(dfraArguments))
    }
}

dependencies {
    testCompileOnly(project(":dfra-activation"))
    testImplementation(project(":dfra-authority"))
    testImplementation(project(":dfra-benchmarks"))
    testImplementation(project(":dfra-fixtures"))
    testImplementation(project(":dfra-recruit"))
    testImplementation(project(":dfra-testing"))
    testImplementation(rootProject.libs.reggie)
    testImplementation(rootProject.libs.archunit)
}

tasks.test { dependsOn(":dfra-client:jar", ":dfra-recruit:dlJar", ":dfra-cli:lib", ":dfra-flight:lib", ":dfra-benchmarks:lib") }

val app = project(":dfra-benchmarks") // it needs all others
val appLib = app.layout.buildDirectory.dir("lib")
val robotLib = project(":dfra-cli").layout.buildDirectory.dir("lib")
val flightLib = project(":dfra-flight").layout.buildDirectory.dir("lib")
val flyingRobotLib = layout.buildDirectory.dir("flying-robot-lib")

tasks.register<Exec>("dist") {
    group = "dfra"
    description = "Packs build/dfra-VERSION.tar.gz for a robot, which runs wherever there is a Java runtime."
    dependsOn(":dfra-cli:lib", ":dfra-activation:jar")
    val boot = project(":dfra-activation").tasks.named<Jar>("jar").get().archiveFile.get().asFile.path
    commandLine("src/dist/pack", robotLib.get().asFile.path, boot, layout.buildDirectory.get().asFile.path)
}

// The same jars from both folders: those of dfra-drivers, say.
val gatherFlyingRobot = tasks.register<Sync>("gatherFlyingRobot") {
    dependsOn(":dfra-cli:lib", ":dfra-flight:lib")
    from(robotLib, flightLib)
    into(flyingRobotLib)
    duplicatesStrategy = DuplicatesStrategy.EXCLUDE
}

tasks.register<Exec>("distFlight") {
    group = "dfra"
    description = "Packs build/dfra-VERSION-flight.tar.gz for a robot that flies: also the drivers of flight controllers."
    dependsOn(gatherFlyingRobot, ":dfra-activation:jar")
    val boot = project(":dfra-activation").tasks.named<Jar>("jar").get().archiveFile.get().asFile.path
    commandLine("src/dist/pack", flyingRobotLib.get().asFile.path, boot, layout.buildDirectory.get().asFile.path, "-flight")
}

tasks.register<Exec>("distComplete") {
    group = "dfra"
    description = "Packs build/dfra-VERSION-complete.tar.gz: also demonstrations, simulation and benchmarks."
    dependsOn(":dfra-benchmarks:lib", ":dfra-activation:jar")
    val boot = project(":dfra-activation").tasks.named<Jar>("jar").get().archiveFile.get().asFile.path
    commandLine("src/dist/pack", appLib.get().asFile.path, boot, layout.buildDirectory.get().asFile.path, "-complete")
}

// The API documentation, as "./dfra javadoc" builds it; pom.xml has the same modules and options.
val undocumented = setOf("dfra-benchmarks", "dfra-fixtures")
val documented = subprojects.filter { it.name !in undocumented }.map { it.the<SourceSetContainer>()["main"] }

tasks.javadoc {
    group = "dfra"
    description = "Builds the API documentation of all modules in build/apidocs; fails if Javadoc has a warning."
    setSource(documented.map { it.allJava })
    exclude("java/rmi/activation/**")
    // Two modules describe this package, and the description of the module with the daemon is the one to show.
    val download = file("dfra-client/src/main/java/org/dfra/river/phoenix/package-info.java")
    exclude { it.file == download }
    classpath = files(documented.map { it.compileClasspath })
    setDestinationDir(layout.buildDirectory.dir("apidocs").get().asFile)
    (options as StandardJavadocDocletOptions).apply {
        encoding = "UTF-8"
        addStringOption("-release", "17")
        addBooleanOption("Xdoclint:all,-missing", true)
        addBooleanOption("Xwerror", true)
        locale = "en"
        isNoTimestamp = true
        windowTitle = "DFRA ${project.version}"
        docTitle = "DFRA ${project.version}"
        bottom = "Licensed under the Apache License."
    }
}

fun JavaExec.runsDfra(what: String, vararg arguments: String) {
    group = "dfra"
    description = what
    dependsOn(":dfra-benchmarks:lib")
    classpath = app.the<SourceSetContainer>()["main"].runtimeClasspath
    mainClass.set("org.dfra.cli.Main")
    args(*arguments)
    systemProperty("dfra.lib", appLib.get().asFile.path)
    standardInput = System.`in`
}

tasks.register<JavaExec>("demo") {
    val name = providers.gradleProperty("demo").orNull
    runsDfra("Runs the raster demonstration, or the one named by -Pdemo=<name>.", *listOfNotNull("demo", name).toTypedArray())
}

tasks.register<JavaExec>("up") {
    val robot = providers.gradleProperty("robot").getOrElse("config/robots/atrv1.xml")
    runsDfra("Brings up the robot described by -Probot=<xml>.", "up", robot)
}

tasks.register<JavaExec>("down") {
    val robot = providers.gradleProperty("robot").orNull
    runsDfra("Takes down the robot named by -Probot=<name or xml>, or without it all robots of this computer and phoenix.", *listOfNotNull("down", robot).toTypedArray())
}

tasks.register<JavaExec>("status") {
    runsDfra("Shows the robots' processes on this computer.", "status")
}
