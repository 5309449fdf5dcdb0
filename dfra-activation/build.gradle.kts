dependencies {
    // Only to see JERI start on the boot class path this jar makes.
    testImplementation(rootProject.libs.jsk.platform)
}

// Maven and the tests read the same file.
tasks.jar { manifest.from("src/main/manifest/MANIFEST.MF") }
