dependencies {
    api(project(":dfra-core"))
    implementation(rootProject.libs.picocli)
    testImplementation(project(":dfra-drivers"))
}
