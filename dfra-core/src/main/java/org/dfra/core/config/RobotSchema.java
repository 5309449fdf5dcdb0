package org.dfra.core.config;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.Validator;
import org.jdom2.Attribute;
import org.jdom2.Element;
import org.jdom2.JDOMException;
import org.jdom2.Namespace;
import org.jdom2.filter.Filters;
import org.jdom2.input.SAXBuilder;
import org.xml.sax.ErrorHandler;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/** The schema of a robot's XML, {@code robot.xsd} beside this class. Touches no network. */
final class RobotSchema {

  /** The namespace of a robot's XML. */
  static final Namespace NAMESPACE = Namespace.getNamespace("urn:dfra:robot:1");

  /** The JDK's parsers and validators take the language of their messages from it. */
  static final String LOCALE = "http://apache.org/xml/properties/locale";

  private static final Namespace XS = Namespace.getNamespace(XMLConstants.W3C_XML_SCHEMA_NS_URI);
  private static final RobotSchema INSTANCE = load();

  private final Schema schema;
  private final Map<String, List<String>> attributes;

  private RobotSchema(Schema schema, Map<String, List<String>> attributes) {
    this.schema = schema;
    this.attributes = attributes;
  }

  /**
   * Notes where a well-formed document departs from the schema, in plain sentences. Of several
   * unknown elements in one element the JDK's validator reports the first.
   */
  static void validate(byte[] document, Place whole, Faults faults) {
    Validator validator = INSTANCE.schema.newValidator();
    try {
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
      validator.setProperty(LOCALE, Locale.ROOT); // SchemaSentence understands English
      validator.setErrorHandler(new Collector(whole, faults));
      validator.validate(new StreamSource(new ByteArrayInputStream(document)));
    } catch (SAXException | IOException e) {
      throw new IllegalStateException("this JDK's validator refuses a well-formed text", e);
    }
  }

  /** Every element there is, with the attributes it may have, in the schema's order. */
  static Map<String, List<String>> attributes() {
    return INSTANCE.attributes;
  }

  private static RobotSchema load() {
    try {
      SchemaFactory factory = SchemaFactory.newDefaultInstance();
      factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
      factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
      byte[] text = text();
      return new RobotSchema(
          factory.newSchema(new StreamSource(new ByteArrayInputStream(text))), declared(text));
    } catch (SAXException | JDOMException | IOException e) {
      throw new IllegalStateException("robot.xsd of this jar is damaged; build it anew", e);
    }
  }

  private static byte[] text() throws IOException {
    try (InputStream in = RobotSchema.class.getResourceAsStream("robot.xsd")) {
      if (in == null) {
        throw new IOException("robot.xsd is missing");
      }
      return in.readAllBytes();
    }
  }

  private static Map<String, List<String>> declared(byte[] text) throws JDOMException, IOException {
    Map<String, List<String>> declared = new TreeMap<>();
    Element root = new SAXBuilder().build(new ByteArrayInputStream(text)).getRootElement();
    for (Element element : root.getDescendants(Filters.element("element", XS))) {
      declared.put(element.getAttributeValue("name"), attributesOf(element));
    }
    return declared;
  }

  private static List<String> attributesOf(Element element) {
    Element type = element.getChild("complexType", XS);
    return type == null
        ? List.of()
        : type.getChildren("attribute", XS).stream()
            .map(attribute -> attribute.getAttribute("name"))
            .map(Attribute::getValue)
            .toList();
  }

  private record Collector(Place whole, Faults faults) implements ErrorHandler {
    @Override
    public void warning(SAXParseException warning) {
      error(warning);
    }

    @Override
    public void error(SAXParseException error) {
      String sentence = SchemaSentence.of(String.valueOf(error.getMessage()), attributes());
      faults.add(new Place(whole.file(), Math.max(0, error.getLineNumber())), sentence);
    }

    @Override
    public void fatalError(SAXParseException error) {
      error(error);
    }
  }
}
