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

/**
 * A type of XML document: its root element, its namespace, and its schema, a resource in a class's
 * package. Reads documents of that type, without network access.
 */
public final class XmlSchema {

  /** The JDK's parsers and validators read the language of their messages from this property. */
  static final String LOCALE = "http://apache.org/xml/properties/locale";

  private static final Namespace XS = Namespace.getNamespace(XMLConstants.W3C_XML_SCHEMA_NS_URI);

  private final String root;
  private final Namespace namespace;
  private final Schema schema;
  private final Map<String, List<String>> attributes;

  /**
   * @param root name of the root element
   * @param namespace the namespace of all its elements
   * @param beside the class whose package contains the schema
   * @param resource the schema's name in it, such as {@code robot.xsd}
   */
  public XmlSchema(String root, String namespace, Class<?> beside, String resource) {
    this.root = root;
    this.namespace = Namespace.getNamespace(namespace);
    try {
      byte[] text = text(beside, resource);
      SchemaFactory factory = SchemaFactory.newDefaultInstance();
      factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
      factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
      this.schema = factory.newSchema(new StreamSource(new ByteArrayInputStream(text)));
      this.attributes = declared(text);
    } catch (SAXException | JDOMException | IOException e) {
      throw new IllegalStateException(resource + " of this jar is damaged; build it anew", e);
    }
  }

  /** Name of the root element. */
  public String root() {
    return root;
  }

  /** The namespace of all its elements. */
  public Namespace namespace() {
    return namespace;
  }

  /** All elements with their permitted attributes, in the schema's order. */
  public Map<String, List<String>> attributes() {
    return attributes;
  }

  /**
   * The root element of a document; it and all its descendants have line numbers. Violations of the
   * schema are recorded as faults.
   *
   * @param whole the file
   * @throws ConfigurationException if the text is not well-formed or it has another root
   */
  public Element read(byte[] text, Place whole, ConfigurationFaults faults) {
    Element element = XmlDocument.parseRoot(text, whole, this);
    validate(text, whole, faults);
    return element;
  }

  /**
   * Records the schema violations of a well-formed document, in plain sentences. Of several unknown
   * elements in one element the JDK's validator reports the first.
   */
  private void validate(byte[] document, Place whole, ConfigurationFaults faults) {
    Validator validator = schema.newValidator();
    try {
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
      validator.setProperty(LOCALE, Locale.ROOT); // SchemaErrorMessage parses English messages
      validator.setErrorHandler(new Collector(this, whole, faults));
      validator.validate(new StreamSource(new ByteArrayInputStream(document)));
    } catch (SAXException | IOException e) {
      throw new IllegalStateException("this JDK's validator refuses a well-formed text", e);
    }
  }

  private static byte[] text(Class<?> beside, String resource) throws IOException {
    try (InputStream in = beside.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IOException(resource + " is missing");
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

  private record Collector(XmlSchema schema, Place whole, ConfigurationFaults faults)
      implements ErrorHandler {
    @Override
    public void warning(SAXParseException warning) {
      error(warning);
    }

    @Override
    public void error(SAXParseException error) {
      String sentence =
          SchemaErrorMessage.of(
              String.valueOf(error.getMessage()), schema.attributes, schema.namespace);
      faults.add(new Place(whole.file(), Math.max(0, error.getLineNumber())), sentence);
    }

    @Override
    public void fatalError(SAXParseException error) {
      error(error);
    }
  }
}
