dependencies {
    api(project(":dfra-core"))
    api(project(":dfra-drivers"))
    testImplementation(project(":dfra-flight"))
    implementation(rootProject.libs.picocli)
    implementation(rootProject.libs.jdom2)
    implementation(rootProject.libs.jackson.databind)
}
