import javax.xml.parsers.DocumentBuilderFactory
import org.w3c.dom.Element

rootProject.name = "dfra"

// pom.xml is the one place where module names and versions are written; both builds read it. Each managed dependency
// of others is in the catalog under its artifactId: jsk-platform is rootProject.libs.jsk.platform in a build script.
// The first letter of each segment is small there: GeographicLib-Java is rootProject.libs.geographicLib.java.
// The file is opened here and not by the parser, so that the configuration cache sees that it was read.
val pom: Element = file("pom.xml").inputStream().use {
    DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(it).documentElement
}
fun Element.children() = (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>()
fun Element.child(name: String) = children().first { it.tagName == name }
fun Element.text(name: String) = child(name).textContent.trim()

pom.child("modules").children().map { it.textContent.trim() }.filter { it.startsWith("dfra-") }.forEach { include(it) }
gradle.allprojects {
    group = pom.text("groupId")
    version = pom.text("version")
}

dependencyResolutionManagement {
    repositories { mavenCentral() }
    versionCatalogs {
        create("libs") {
            val versions = pom.child("properties").children().associate { it.tagName to it.textContent.trim() }
            pom.child("dependencyManagement").child("dependencies").children()
                .filter { it.text("groupId") != "org.dfra" }
                .forEach {
                    val version = it.text("version").removeSurrounding("\${", "}")
                    val alias = it.text("artifactId").replaceFirstChar(Char::lowercase) // Gradle takes no capital there
                    library(alias, it.text("groupId"), it.text("artifactId")).version(versions.getValue(version))
                }
        }
    }
}
