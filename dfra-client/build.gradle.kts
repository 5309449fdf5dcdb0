// A client downloads dfra-client.jar and dfra-api.jar, and has River: nothing else may be needed here.
dependencies {
    api(project(":dfra-api"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    api(rootProject.libs.jsk.platform)
    api(rootProject.libs.jsk.lib)
    testImplementation(project(":dfra-core"))
    testImplementation(project(":dfra-fixtures"))
}
