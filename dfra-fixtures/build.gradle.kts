// What the tests of several modules share is its main code, so JUnit and the like are needed to compile it.
dependencies {
    api(project(":dfra-api"))
    api(rootProject.libs.jsk.platform)
    // Writes the certificates of tests, as the authority's tool writes those of robots.
    api(rootProject.libs.bcpkix.jdk18on)
    api(rootProject.libs.junit.jupiter)
    api(rootProject.libs.assertj.core)
    api(rootProject.libs.awaitility)
}
