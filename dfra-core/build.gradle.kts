dependencies {
    api(project(":dfra-api"))
    implementation(rootProject.libs.jdom2)
    implementation(rootProject.libs.ejml.ddense)
    api(rootProject.libs.jackson.databind)
    api(rootProject.libs.slf4j.api)
}
