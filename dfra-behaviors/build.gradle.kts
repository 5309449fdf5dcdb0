dependencies {
    api(project(":dfra-core"))
}
