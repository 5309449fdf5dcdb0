dependencies {
    api(project(":dfra-api"))
    api(rootProject.libs.jdom2)
    api(rootProject.libs.slf4j.api)
}
