plugins { `java-library` }

// The root project's own sources are src/test: the integration tests that span the modules.
allprojects { apply(plugin = "java-library") }

allprojects {
    tasks.withType<JavaCompile>().configureEach {
        options.release.set(17)
        options.encoding = "UTF-8"
        // Else each place that joins strings is linked when it first runs, again in every process that starts.
        options.compilerArgs.addAll(
            listOf("-Xlint:all,-serial,-removal,-processing,-options", "-parameters", "-XDstringConcat=inline"))
    }
    // Jar names carry no version, in either build: class paths and codebases name them.
    // And the same sources give the same bytes, as pom.xml's outputTimestamp has it.
    tasks.withType<Jar>().configureEach {
        archiveVersion.set("")
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
    }

    dependencies {
        "compileOnly"(rootProject.libs.jspecify)
        "testCompileOnly"(rootProject.libs.jspecify)
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
        listOf("-Xbootclasspath/a:$boot", "-Ddfra.boot=$boot", "-Ddfra.root=$top")
    }
    val full = providers.gradleProperty("dfra.full").getOrElse("false")
    val soak = providers.gradleProperty("dfra.soak").getOrElse("false")
    val repeats = providers.gradleProperty("dfra.repeats").getOrElse("false")
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
        systemProperty("dfra.repeats", repeats)
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
    testImplementation(project(":dfra-app"))
    testImplementation(project(":dfra-recruit"))
    testImplementation(project(":dfra-testing"))
    testImplementation(rootProject.libs.reggie)
    testImplementation(rootProject.libs.archunit)
}

tasks.test { dependsOn(":dfra-river:dlJar", ":dfra-recruit:dlJar", ":dfra-app:lib") }

val app = project(":dfra-app")
val appLib = app.layout.buildDirectory.dir("lib")

tasks.register<Exec>("dist") {
    group = "dfra"
    description = "Packs build/dfra-VERSION.tar.gz, which runs wherever there is a Java runtime."
    dependsOn(":dfra-app:lib", ":dfra-activation:jar")
    val boot = project(":dfra-activation").tasks.named<Jar>("jar").get().archiveFile.get().asFile.path
    commandLine("src/dist/pack", appLib.get().asFile.path, boot, layout.buildDirectory.get().asFile.path)
}

fun JavaExec.runsDfra(what: String, vararg arguments: String) {
    group = "dfra"
    description = what
    dependsOn(":dfra-app:lib")
    classpath = app.the<SourceSetContainer>()["main"].runtimeClasspath
    mainClass.set("org.dfra.app.Main")
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
