package org.dfra.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.dfra.build.BuildModel.Dependency;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/**
 * Reads the {@code pom.xml} files: the modules, their dependencies, and the one place of versions.
 */
final class MavenBuild {

  private final Path root;
  private final Element pom;

  MavenBuild(Path root) {
    this.root = root;
    this.pom = parse(root.resolve("pom.xml"));
  }

  BuildModel model() {
    Map<String, Set<Dependency>> modules = new LinkedHashMap<>();
    for (Element module : children(child(pom, "modules"))) {
      String directory = module.getTextContent().trim();
      Element project = parse(root.resolve(directory).resolve("pom.xml"));
      Set<Dependency> needs = dependencies(project);
      Set<String> own = needs.stream().map(Dependency::name).collect(Collectors.toSet());
      dependencies(pom).stream() // what a module says of a dependency goes before what all say
          .filter(inherited -> !own.contains(inherited.name()))
          .forEach(needs::add);
      needs.addAll(annotationProcessors(project));
      modules.put(directory, needs);
    }
    return new BuildModel("Maven", modules);
  }

  /** The version of each managed dependency by {@code group:artifact}, properties resolved. */
  Map<String, String> managedVersions() {
    Map<String, String> versions = new LinkedHashMap<>();
    for (Element dependency : children(child(child(pom, "dependencyManagement"), "dependencies"))) {
      versions.put(name(dependency), resolve(text(dependency, "version", "")));
    }
    return versions;
  }

  /**
   * Managed dependencies whose version is a number, not a property: Gradle's settings could not
   * read it.
   */
  List<String> managedWithoutProperty() {
    return children(child(child(pom, "dependencyManagement"), "dependencies")).stream()
        .filter(dependency -> !text(dependency, "version", "").startsWith("${"))
        .map(MavenBuild::name)
        .toList();
  }

  /** How the root's {@code pom.xml} configures a plugin that it manages: each element's text. */
  Map<String, String> configuration(String plugin) {
    Map<String, String> texts = new LinkedHashMap<>();
    Element management = child(child(pom, "build"), "pluginManagement");
    children(child(management, "plugins")).stream()
        .filter(each -> text(each, "artifactId", "").equals(plugin))
        .flatMap(each -> children(child(each, "configuration")).stream())
        .forEach(each -> texts.put(each.getTagName(), each.getTextContent().trim()));
    return texts;
  }

  private Set<Dependency> dependencies(Element project) {
    Map<String, String> managed = managedVersions();
    Set<Dependency> result = new TreeSet<>();
    Set<String> seen = new HashSet<>();
    for (Element dependency : children(child(project, "dependencies"))) {
      String name = name(dependency);
      if (!seen.add(name)) {
        throw new IllegalStateException(name + " twice in the dependencies of one pom.xml");
      }
      String version =
          resolve(text(dependency, "version", managed.getOrDefault(name, "no managed version")));
      result.add(new Dependency(name, version, text(dependency, "scope", "compile")));
    }
    return result;
  }

  /**
   * Those of a module's own {@code pom.xml}. The root's are Error Prone and NullAway, which only
   * Maven runs.
   */
  private Set<Dependency> annotationProcessors(Element project) {
    Set<Dependency> result = new TreeSet<>();
    NodeList all = project.getElementsByTagName("annotationProcessorPaths");
    for (int i = 0; i < all.getLength(); i++) {
      for (Element path : children((Element) all.item(i))) {
        String version = resolve(text(path, "version", "no version"));
        result.add(new Dependency(name(path), version, "annotationProcessor"));
      }
    }
    return result;
  }

  private String resolve(String version) {
    if (version.equals("${project.version}")) {
      return text(pom, "version", "");
    }
    return version.startsWith("${")
        ? text(
            child(pom, "properties"),
            version.substring(2, version.length() - 1),
            "undefined " + version)
        : version;
  }

  private static String name(Element dependency) {
    return text(dependency, "groupId", "") + ":" + text(dependency, "artifactId", "");
  }

  private static String text(Element parent, String name, String otherwise) {
    return children(parent).stream()
        .filter(element -> element.getTagName().equals(name))
        .map(element -> element.getTextContent().trim())
        .findFirst()
        .orElse(otherwise);
  }

  /** The first child of that name, or an element without children. */
  private static Element child(Element parent, String name) {
    return children(parent).stream()
        .filter(element -> element.getTagName().equals(name))
        .findFirst()
        .orElseGet(() -> parent.getOwnerDocument().createElement(name));
  }

  private static List<Element> children(Element parent) {
    NodeList nodes = parent.getChildNodes();
    return IntStream.range(0, nodes.getLength())
        .mapToObj(nodes::item)
        .filter(Element.class::isInstance)
        .map(Element.class::cast)
        .toList();
  }

  private static Element parse(Path file) {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(file.toFile())
          .getDocumentElement();
    } catch (SAXException | IOException | ParserConfigurationException e) {
      throw new IllegalStateException("cannot read " + file + ": " + e.getMessage(), e);
    }
  }
}
