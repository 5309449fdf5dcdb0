// dfra-api needs the JDK only; its tests ask somebody else's geodesy.
dependencies {
    testImplementation(rootProject.libs.geographicLib.java)
}
