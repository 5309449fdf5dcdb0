package org.dfra.core.policy;

import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ConfigurationFaults;
import org.dfra.core.config.SourceFile;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.config.XmlSchema;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.jdom2.Element;

/**
 * Reads policies. The XML's reference is {@code docs/reference/policy.md}, its schema {@code
 * policy.xsd}. Variables are not substituted: a policy means the same on every computer.
 */
public final class PolicyXml {

  /** The largest policy in bytes. */
  public static final int MAX_BYTES = 256 << 10;

  /** The most rules of a policy. */
  public static final int MAX_RULES = 500;

  /** The most budgets and radios of a policy: each may be about every call. */
  public static final int MAX_BUDGETS = 50;

  /** The most rules about what lookup services show: a bit of a long for each. */
  public static final int MAX_VISIBILITY_RULES = 64;

  private static final XmlSchema SCHEMA =
      new XmlSchema("policy", "urn:dfra:policy:1", PolicyXml.class, "policy.xsd");

  private PolicyXml() {}

  /**
   * Reads a policy.
   *
   * @param catalogue the interfaces that it may name
   * @throws ConfigurationException with every fault in it, a line each
   */
  public static Policy read(Path file, InterfaceCatalogue catalogue) {
    return read(SourceFile.readBytes(file, "a policy"), file.toString(), catalogue);
  }

  /**
   * Reads a policy from its bytes.
   *
   * @param name of the file, for the places in messages
   * @param catalogue the interfaces that it may name
   * @throws ConfigurationException with every fault in it, a line each
   */
  public static Policy read(byte[] text, String name, InterfaceCatalogue catalogue) {
    return read(text, name, catalogue, false);
  }

  /**
   * Reads a policy.
   *
   * @param isValid whether the schema has been found to permit exactly this text
   */
  static Policy read(byte[] text, String name, InterfaceCatalogue catalogue, boolean isValid) {
    SourceLocation whole = new SourceLocation(name, 0);
    if (text.length > MAX_BYTES) {
      throw new ConfigurationException(
          whole
              + ": the policy has "
              + text.length
              + " bytes, at most "
              + MAX_BYTES
              + " are read; combine rules");
    }
    ConfigurationFaults faults = new ConfigurationFaults();
    Element root =
        isValid ? SCHEMA.readValid(text, whole, faults) : SCHEMA.read(text, whole, faults);
    Optional<Policy> policy = new PolicyReader(name, catalogue, faults).policy(root, digest(text));
    faults.throwIfAny();
    return policy.orElseThrow();
  }

  /**
   * Which policy a text is, even if it has faults here, such as an interface that is not on this
   * computer.
   *
   * @throws ConfigurationException if the text is not well-formed, or no policy with a version
   */
  static PolicyIdentity identity(byte[] text, String name) {
    Element root = SCHEMA.read(text, new SourceLocation(name, 0), new ConfigurationFaults());
    ConfigurationFaults faults = new ConfigurationFaults();
    long version = new PolicyReader(name, InterfaceCatalogue.builtIn(), faults).version(root);
    faults.throwIfAny();
    return new PolicyIdentity(
        String.valueOf(root.getAttributeValue("team")), version, digest(text));
  }

  /** What only this text and the schema of this DFRA have in common. */
  static String checksum(byte[] text) {
    return SCHEMA.checksum(text);
  }

  private static String digest(byte[] text) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  /** All elements with their permitted attributes, in the schema's order. */
  static Map<String, List<String>> attributes() {
    return SCHEMA.attributes();
  }

  /** The namespace of all elements. */
  static String namespace() {
    return SCHEMA.namespace().getURI();
  }
}
