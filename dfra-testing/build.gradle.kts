dependencies {
    api(project(":dfra-river"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    runtimeOnly(rootProject.libs.reggie)
    // Its extension is for the tests of others, so JUnit is needed wherever it is used.
    api(rootProject.libs.junit.jupiter)
}
