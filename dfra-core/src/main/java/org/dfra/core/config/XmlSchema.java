package org.dfra.core.config;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.CRC32C;
import javax.xml.XMLConstants;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import javax.xml.transform.sax.SAXSource;
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
import org.jspecify.annotations.Nullable;
import org.xml.sax.ErrorHandler;
import org.xml.sax.InputSource;
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

  private static final String MARK = "<!-- valid %08x -->\n";

  private static final int MARK_LENGTH = String.format(Locale.ROOT, MARK, 0).length();

  private final String root;
  private final Namespace namespace;
  private final Class<?> beside;
  private final String resource;

  // compiled at the first validation
  @GuardedBy("this")
  private @Nullable Schema schema;

  @GuardedBy("this")
  private @Nullable Map<String, List<String>> attributes;

  /**
   * @param root name of the root element
   * @param namespace the namespace of all its elements
   * @param beside the class whose package contains the schema
   * @param resource the schema's name in it, such as {@code robot.xsd}
   */
  public XmlSchema(String root, String namespace, Class<?> beside, String resource) {
    this.root = root;
    this.namespace = Namespace.getNamespace(namespace);
    this.beside = beside;
    this.resource = resource;
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
  public synchronized Map<String, List<String>> attributes() {
    if (attributes == null) {
      try {
        attributes = declared(text());
      } catch (JDOMException | IOException e) {
        throw damaged(e);
      }
    }
    return attributes;
  }

  private synchronized Schema schema() {
    if (schema == null) {
      SchemaFactory factory = SchemaFactory.newDefaultInstance();
      try {
        factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
        factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
        schema = factory.newSchema(new StreamSource(new ByteArrayInputStream(text())));
      } catch (SAXException | IOException e) {
        throw damaged(e);
      }
    }
    return schema;
  }

  private IllegalStateException damaged(Exception cause) {
    return new IllegalStateException(resource + " of this jar is damaged; rebuild DFRA", cause);
  }

  /**
   * The root element of a document; it and all its descendants have line numbers. Violations of the
   * schema are recorded as faults.
   *
   * @param whole the file
   * @throws ConfigurationException if the text is not well-formed or it has another root
   */
  public Element read(byte[] text, SourceLocation whole, ConfigurationFaults faults) {
    Element element = XmlDocument.parseRoot(text, whole, this, faults);
    if (!isMarked(text)) {
      validate(text, whole, faults);
    }
    return element;
  }

  /**
   * Reads a document that was found valid before, without validating it again: to compile the
   * schema takes longer than all else that a process does with a short document.
   *
   * @param whole the file
   * @throws ConfigurationException if the text is not well-formed or it has another root
   */
  public Element readValid(byte[] text, SourceLocation whole, ConfigurationFaults faults) {
    return XmlDocument.parseRoot(text, whole, this, faults);
  }

  /**
   * What only this document and this schema have in common, for a note that the document is valid:
   * the note no longer fits if either of them changes.
   *
   * @return a checksum by SHA-256, in hexadecimal digits
   */
  public String checksum(byte[] document) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(digest.digest(text()));
      return HexFormat.of().formatHex(digest.digest(document));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    } catch (IOException e) {
      throw damaged(e);
    }
  }

  /**
   * The same document with a last line that marks it as valid, so that reading it needs no compiled
   * schema: an emergency stop would wait 0.2 s for that. The mark is no longer true if the document
   * or the schema changes.
   *
   * @param document a valid one
   */
  String marked(String document) {
    return document + mark(document.getBytes(StandardCharsets.UTF_8));
  }

  private boolean isMarked(byte[] text) {
    int length = text.length - MARK_LENGTH;
    if (length < 0 || text[length] != '<') {
      return false;
    }
    String last = new String(text, length, MARK_LENGTH, StandardCharsets.US_ASCII);
    return last.equals(mark(Arrays.copyOf(text, length)));
  }

  private String mark(byte[] document) {
    CRC32C crc = new CRC32C();
    crc.update(document);
    try {
      crc.update(text());
    } catch (IOException e) {
      throw damaged(e);
    }
    return String.format(Locale.ROOT, MARK, (int) crc.getValue());
  }

  /**
   * Records the schema violations of a well-formed document, in plain sentences. Of several unknown
   * elements in one element the JDK's validator reports the first.
   */
  private void validate(byte[] document, SourceLocation whole, ConfigurationFaults faults) {
    Validator validator = schema().newValidator();
    try {
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
      validator.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
      validator.setProperty(LOCALE, Locale.ROOT); // SchemaErrorMessage parses English messages
      validator.setErrorHandler(new Collector(this, whole, faults));
      RenamedAttributes reader = renamedAttributes(whole, faults);
      reader.setParent(SAXParserFactory.newDefaultNSInstance().newSAXParser().getXMLReader());
      validator.validate(
          new SAXSource(reader, new InputSource(new ByteArrayInputStream(document))));
    } catch (SAXException | ParserConfigurationException | IOException e) {
      throw new IllegalStateException("this JDK's validator refuses a well-formed text", e);
    }
  }

  /** A filter that replaces old names of attributes. */
  RenamedAttributes renamedAttributes(SourceLocation whole, ConfigurationFaults faults) {
    return new RenamedAttributes(namespace.getURI(), whole, faults);
  }

  private byte[] text() throws IOException {
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

  private record Collector(XmlSchema schema, SourceLocation whole, ConfigurationFaults faults)
      implements ErrorHandler {
    @Override
    public void warning(SAXParseException warning) {
      error(warning);
    }

    @Override
    public void error(SAXParseException error) {
      String sentence =
          SchemaErrorMessage.of(
              String.valueOf(error.getMessage()), schema.attributes(), schema.namespace);
      faults.add(new SourceLocation(whole.file(), Math.max(0, error.getLineNumber())), sentence);
    }

    @Override
    public void fatalError(SAXParseException error) {
      error(error);
    }
  }
}
