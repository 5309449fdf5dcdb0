dependencies {
    api(project(":dfra-core"))
    api(project(":dfra-drivers"))
    implementation(rootProject.libs.mavlink)
    implementation(rootProject.libs.slf4j.api)
}

// The fixtures of the other drivers' tests: stepped time, scripted links, what scanners of frames must do. A module of
// their own would need dfra-drivers, whose tests need them. pom.xml has the same folder.
sourceSets.test { java.srcDir("../dfra-drivers/src/test/java/org/dfra/drivers/fixture") }

tasks.register<Sync>("lib") {
    group = "dfra"
    description = "Gathers in build/lib what these drivers need: this jar, MAVLink, and what every robot has."
    from(tasks.named("jar"), configurations.named("runtimeClasspath"))
    into(layout.buildDirectory.dir("lib"))
}
