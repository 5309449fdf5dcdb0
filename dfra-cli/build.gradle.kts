dependencies {
    api(project(":dfra-report"))
    api(project(":dfra-river"))
    api(project(":dfra-drivers"))
    api(project(":dfra-recruit"))
    testImplementation(project(":dfra-sim"))
    testImplementation(project(":dfra-flight"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    runtimeOnly(rootProject.libs.jsk.resources)
    runtimeOnly(rootProject.libs.reggie)
    implementation(rootProject.libs.logback.classic)
}

tasks.register<Sync>("lib") {
    group = "dfra"
    description = "Gathers in build/lib what a robot has: this jar, the other modules', and what they need."
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
