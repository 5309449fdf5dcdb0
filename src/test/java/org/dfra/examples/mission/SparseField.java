package org.dfra.examples.mission;

import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.transform.TransformerFactory;
import javax.xml.transform.dom.DOMSource;
import javax.xml.transform.stream.StreamResult;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

/**
 * The field and the robots of {@code raster.xml}, made small for tests that are not about driving
 * around what is in the way: robots that start beside what they search, in a field without posts
 * and mines, with fewer processes and ten scans of the laser in a second.
 */
public final class SparseField {

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));
  private static final Path MODULES = ROOT.resolve("config/modules");

  /**
   * Where a robot starts.
   *
   * @param east metres
   * @param north metres
   * @param yaw radians, 0 is east, counter-clockwise is +
   */
  public record Start(double east, double north, double yaw) {}

  private SparseField() {}

  /**
   * Writes the world and returns its file, {@code raster.xml}.
   *
   * @param starts by the names of the robots that are in it
   */
  public static Path world(Path folder, Map<String, Start> starts) throws Exception {
    Document world = read(ROOT.resolve("config/worlds/raster.xml"));
    for (String kind : List.of("post", "mine")) {
      elements(world, kind).forEach(SparseField::remove);
    }
    for (Element robot : elements(world, "robot")) {
      Start start = starts.get(robot.getAttribute("name"));
      if (start == null) {
        remove(robot);
      } else {
        robot.setAttribute("east", Double.toString(start.east()));
        robot.setAttribute("north", Double.toString(start.north()));
        robot.setAttribute("yaw", Double.toString(start.yaw()));
      }
    }
    return write(world, folder.resolve("raster.xml"));
  }

  /**
   * Writes a robot's description and returns its file, {@code NAME.xml}.
   *
   * @param into the group that the registrar and the modules of all other groups move to
   * @param separation groups that stay as they are
   */
  public static Path robot(Path folder, String name, String into, Set<String> separation)
      throws Exception {
    return robot("raster", folder, name, into, separation);
  }

  /** The same for a robot of another team. */
  public static Path robot(
      String team, Path folder, String name, String into, Set<String> separation) throws Exception {
    Document robot = read(ROOT.resolve("config/teams/" + team + "/" + name + ".xml"));
    Element together =
        elements(robot, "group").stream()
            .filter(each -> each.getAttribute("name").equals(into))
            .findFirst()
            .orElseThrow();
    for (Element module : elements(robot, "module")) {
      Path properties = Path.of(module.getAttribute("properties")).getFileName();
      module.setAttribute("properties", MODULES.resolve(properties).toString());
      Element group = (Element) module.getParentNode();
      if (group != together && !separation.contains(group.getAttribute("name"))) {
        together.appendChild(module);
        if (group.getElementsByTagName("module").getLength() == 0) {
          remove(group);
        }
      }
    }
    for (Element registrar : elements(robot, "registrar")) {
      Element group = (Element) registrar.getParentNode();
      if (group != together && !separation.contains(group.getAttribute("name"))) {
        together.insertBefore(registrar, together.getElementsByTagName("module").item(0));
        remove(group);
      }
    }
    for (Element parameter : elements(robot, "parameter")) {
      if (parameter.getAttribute("name").equals("baud")) {
        parameter.setAttribute("value", "38400"); // as fast as its line lets it
      }
    }
    return write(robot, folder.resolve(name + ".xml"));
  }

  private static void remove(Node node) {
    node.getParentNode().removeChild(node);
  }

  /** As they are now, however the document changes. */
  private static List<Element> elements(Document document, String name) {
    NodeList found = document.getElementsByTagName(name);
    List<Element> elements = new ArrayList<>();
    for (int i = 0; i < found.getLength(); i++) {
      elements.add((Element) found.item(i));
    }
    return elements;
  }

  private static Document read(Path file) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(Files.readString(file))));
  }

  private static Path write(Document document, Path file) throws Exception {
    StringWriter text = new StringWriter();
    TransformerFactory.newInstance()
        .newTransformer()
        .transform(new DOMSource(document), new StreamResult(text));
    return Files.writeString(file, text.toString());
  }
}
