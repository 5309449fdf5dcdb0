dependencies {
    api(project(":dfra-core"))
    implementation(rootProject.libs.jts.core)
    implementation(rootProject.libs.ejml.ddense)
}
