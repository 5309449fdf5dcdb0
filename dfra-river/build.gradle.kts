dependencies {
    api(project(":dfra-core"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    api(rootProject.libs.jsk.platform)
    api(rootProject.libs.jsk.lib)
    api(rootProject.libs.jul.to.slf4j)
}

// dfra-river-dl.jar: what a client without dfra-river downloads. pom.xml has the same list.
val dlJar = tasks.register<Jar>("dlJar") {
    archiveClassifier.set("dl")
    from(sourceSets.main.get().output)
    include(
        "org/dfra/river/remote/**",
        "org/dfra/river/proxy/**",
        "org/dfra/river/entry/**",
        "org/dfra/river/access/**",
        "org/dfra/river/call/**",
        "org/dfra/river/filter/**",
        "org/dfra/river/phoenix/JeriActivationID*.class",
    )
}
tasks.assemble { dependsOn(dlJar) }
