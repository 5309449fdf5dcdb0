dependencies {
    api(project(":dfra-core"))
    implementation(rootProject.libs.slf4j.api)
    implementation(rootProject.libs.picocli)
    testImplementation(project(":dfra-drivers"))
    testImplementation(rootProject.libs.logback.classic)
}
