dependencies {
    api(project(":dfra-experiments"))
    // What ./dfra runs in a checkout is the class path of this module: it has all verbs.
    implementation(project(":dfra-authority"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    implementation(rootProject.libs.commons.statistics.inference)
    implementation(rootProject.libs.jmh.core)
    implementation(rootProject.libs.jeromq)
    annotationProcessor(rootProject.libs.jmh.generator.annprocess)
}

// As pom.xml has it: Batik's canvas needs them for embedded bitmaps only, and no panel embeds one.
configurations.configureEach { exclude(group = "org.apache.xmlgraphics", module = "xmlgraphics-commons") }

tasks.register<Sync>("lib") {
    group = "dfra"
    description = "Gathers the class path of ./dfra in build/lib: this jar, the other modules', and what they need."
    from(tasks.named("jar"), configurations.named("runtimeClasspath"))
    into(layout.buildDirectory.dir("lib"))
    // What a class server serves; it is not on the class path.
    into("dl") {
        from(
            project(":dfra-api").tasks.named("jar"),
            project(":dfra-client").tasks.named("jar"),
            project(":dfra-recruit").tasks.named("dlJar"),
        )
    }
}
