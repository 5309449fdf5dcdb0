dependencies {
    api(project(":dfra-river"))
    api(project(":dfra-drivers"))
    api(project(":dfra-behaviors"))
    api(project(":dfra-recruit"))
    api(project(":dfra-sim"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    api(rootProject.libs.picocli)
    runtimeOnly(rootProject.libs.jsk.resources)
    runtimeOnly(rootProject.libs.reggie)
    implementation(rootProject.libs.jackson.databind)
    implementation(rootProject.libs.jackson.datatype.jsr310)
    implementation(rootProject.libs.jackson.datatype.jdk8)
    implementation(rootProject.libs.logback.classic)
    implementation(rootProject.libs.xchart)
    implementation(rootProject.libs.batik.svggen)
    implementation(rootProject.libs.jts.core)
    implementation(rootProject.libs.commons.statistics.inference)
    implementation(rootProject.libs.commons.statistics.interval)
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
            project(":dfra-river").tasks.named("dlJar"),
            project(":dfra-recruit").tasks.named("dlJar"),
        )
    }
}
