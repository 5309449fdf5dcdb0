dependencies {
    api(project(":dfra-cli"))
    compileOnly(project(":dfra-activation"))
    testCompileOnly(project(":dfra-activation"))
    implementation(rootProject.libs.bcpkix.jdk18on)
    implementation(rootProject.libs.jackson.databind)
}
