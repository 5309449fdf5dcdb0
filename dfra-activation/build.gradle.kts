dependencies {
    // Only to see River use what this jar puts on the boot class path.
    testImplementation(rootProject.libs.jsk.platform)
}

// Maven and the tests read the same file.
tasks.jar { manifest.from("src/main/manifest/MANIFEST.MF") }

tasks.test {
    systemProperty("dfra.boot-class-path", layout.buildDirectory.dir("classes/java/main").get().asFile.path)
    systemProperty("dfra.root", rootDir.path)
}
