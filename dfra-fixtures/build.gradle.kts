// What the tests of several modules share is its main code, so JUnit and the like are needed to compile it.
dependencies {
    api(project(":dfra-api"))
    api(rootProject.libs.jsk.platform)
    api(rootProject.libs.bcpkix.jdk18on)
    api(rootProject.libs.junit.jupiter)
    api(rootProject.libs.assertj.core)
    api(rootProject.libs.awaitility)
}
