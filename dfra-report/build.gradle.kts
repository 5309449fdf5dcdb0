dependencies {
    api(project(":dfra-behaviors"))
    api(rootProject.libs.picocli)
    implementation(rootProject.libs.jackson.databind)
    implementation(rootProject.libs.jackson.datatype.jdk8)
    // A module that draws plots adds it, as dfra-examples does. A robot has the tables without the plots.
    compileOnly(rootProject.libs.xchart)
    compileOnly(rootProject.libs.batik.svggen)
    testImplementation(rootProject.libs.xchart)
    testImplementation(rootProject.libs.batik.svggen)
}

// As pom.xml has it: Batik's canvas needs them for embedded bitmaps only, and no panel embeds one.
configurations.configureEach { exclude(group = "org.apache.xmlgraphics", module = "xmlgraphics-commons") }
