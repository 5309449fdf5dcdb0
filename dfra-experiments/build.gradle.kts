dependencies {
    api(project(":dfra-examples"))
    implementation(rootProject.libs.commons.statistics.inference)
    implementation(rootProject.libs.commons.statistics.interval)
}

// As pom.xml has it: Batik's canvas needs them for embedded bitmaps only, and no panel embeds one.
configurations.configureEach { exclude(group = "org.apache.xmlgraphics", module = "xmlgraphics-commons") }
