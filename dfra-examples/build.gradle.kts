dependencies {
    api(project(":dfra-cli"))
    api(project(":dfra-sim"))
    // Robots of its teams fly; their properties name the drivers.
    runtimeOnly(project(":dfra-flight"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    implementation(rootProject.libs.xchart)
    implementation(rootProject.libs.batik.svggen)
    implementation(rootProject.libs.jts.core)
}

// As pom.xml has it: Batik's canvas needs them for embedded bitmaps only, and no panel embeds one.
configurations.configureEach { exclude(group = "org.apache.xmlgraphics", module = "xmlgraphics-commons") }
