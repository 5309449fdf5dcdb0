dependencies {
    api(project(":dfra-api"))
    implementation(rootProject.libs.jdom2)
    api(rootProject.libs.slf4j.api)
}
