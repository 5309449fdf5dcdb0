dependencies {
    api(project(":dfra-client"))
    api(project(":dfra-phoenix"))
    api(project(":dfra-core"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    api(rootProject.libs.jsk.platform)
    api(rootProject.libs.jsk.lib)
    testImplementation(project(":dfra-fixtures"))
}
