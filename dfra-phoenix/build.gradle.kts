dependencies {
    api(project(":dfra-client"))
    api(project(":dfra-core"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    api(rootProject.libs.jsk.platform)
    api(rootProject.libs.jsk.lib)
    api(rootProject.libs.jul.to.slf4j)
    testImplementation(project(":dfra-fixtures"))
}
