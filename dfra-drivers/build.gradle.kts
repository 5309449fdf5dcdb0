dependencies {
    api(project(":dfra-core"))
    api(rootProject.libs.slf4j.api)
    implementation(rootProject.libs.jSerialComm)
    implementation(rootProject.libs.jackson.core)
    testImplementation(rootProject.libs.jackson.databind)
    testImplementation(rootProject.libs.logback.classic)
}
