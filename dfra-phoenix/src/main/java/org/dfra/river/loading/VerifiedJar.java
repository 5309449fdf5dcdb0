package org.dfra.river.loading;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.security.CodeSigner;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import org.dfra.river.loading.CodeTrust.DownloadLimits;
import org.jspecify.annotations.Nullable;

/**
 * The contents of a jar, read once, in memory: classes are defined from the same bytes whose
 * signatures are checked.
 */
final class VerifiedJar {

  private final Map<String, Content> contents;

  private VerifiedJar(Map<String, Content> contents) {
    this.contents = contents;
  }

  /** One file of a jar. */
  record Content(byte[] bytes, CodeSigner @Nullable [] signers) {}

  /** The contents of the jar under a name such as {@code org/example/A.class}, or null. */
  @Nullable Content content(String name) {
    return contents.get(name);
  }

  /**
   * Reads a jar, and verifies its signatures.
   *
   * @param url its source, for messages
   * @throws CodeRefusedException if an entry does not match its signature, or it exceeds the limits
   */
  static VerifiedJar read(CodebaseUrl url, byte[] bytes, DownloadLimits limits) {
    Map<String, Content> contents = new HashMap<>();
    try (JarInputStream in = new JarInputStream(new ByteArrayInputStream(bytes), true)) {
      long left = limits.unpackedBytes();
      for (JarEntry entry; (entry = in.getNextJarEntry()) != null; ) {
        byte[] content = in.readNBytes((int) Math.min(left + 1, Integer.MAX_VALUE - 8));
        left -= content.length;
        if (left < 0 || contents.size() >= limits.entries()) {
          throw refused(
              url,
              "it unpacks to more than "
                  + limits.unpackedBytes()
                  + " bytes or "
                  + limits.entries()
                  + " entries; raise download.unpacked.bytes or download.entries to load it");
        }
        if (entry.isDirectory() || isSignature(entry.getName())) {
          continue; // nothing can be loaded from them, so they need no signature
        }
        Content read = new Content(content, entry.getCodeSigners());
        if (contents.put(entry.getName(), read) != null) {
          throw refused(url, "it contains " + entry.getName() + " twice; rebuild it");
        }
      }
    } catch (CodeRefusedException e) {
      throw e;
    } catch (SecurityException e) {
      throw refused(
          url, "it was altered after it was signed (" + e.getMessage() + "); sign it again", e);
    } catch (IOException | IllegalArgumentException e) {
      throw refused(url, "it is not a jar (" + e.getMessage() + "); rebuild it", e);
    }
    if (contents.isEmpty()) {
      throw refused(url, "it is not a jar, or it is empty; rebuild it");
    }
    return new VerifiedJar(contents);
  }

  /**
   * Requires that every entry is signed by one of these keys.
   *
   * @param trusted certificates of the trust file
   * @param team the keys of the team of this computer; null if it has joined none
   * @throws CodeRefusedException naming an entry that is not
   */
  void requireSigned(CodebaseUrl url, Set<X509Certificate> trusted, @Nullable TeamSigners team) {
    boolean signedAtAll = contents.values().stream().anyMatch(content -> content.signers() != null);
    if (!signedAtAll) {
      throw refused(
          url,
          "the jar is not signed, and its digest alone says nothing of who made it; sign it with a"
              + " trusted key, or pin its digest");
    }
    contents.forEach((name, content) -> requireSigned(url, name, content.signers(), trusted, team));
  }

  private static void requireSigned(
      CodebaseUrl url,
      String name,
      CodeSigner @Nullable [] signers,
      Set<X509Certificate> trusted,
      @Nullable TeamSigners team) {
    if (signers == null) {
      throw refused(url, "its entry " + name + " is not signed; sign the whole jar");
    }
    String fault = "";
    for (CodeSigner signer : signers) {
      List<X509Certificate> chain = chain(signer);
      Optional<String> refusal =
          trusted.contains(chain.get(0)) ? datesFault(chain.get(0)) : teamFault(name, chain, team);
      if (refusal.isEmpty()) {
        return;
      }
      fault = fault.isEmpty() ? refusal.get() : fault;
    }
    throw refused(url, fault);
  }

  private static List<X509Certificate> chain(CodeSigner signer) {
    return signer.getSignerCertPath().getCertificates().stream()
        .map(X509Certificate.class::cast)
        .toList();
  }

  private static Optional<String> datesFault(X509Certificate leaf) {
    try {
      leaf.checkValidity();
      return Optional.empty();
    } catch (CertificateException e) {
      return Optional.of(
          "the certificate of its signer "
              + leaf.getSubjectX500Principal()
              + " is valid only from "
              + leaf.getNotBefore().toInstant()
              + " to "
              + leaf.getNotAfter().toInstant()
              + "; renew it, or set the clock");
    }
  }

  private static Optional<String> teamFault(
      String name, List<X509Certificate> chain, @Nullable TeamSigners team) {
    String signed = "its entry " + name + " is signed by " + chain.get(0).getSubjectX500Principal();
    if (team == null) {
      return Optional.of(
          signed
              + ", whose key is not trusted here; add the certificate to the trust file if it"
              + " should be");
    }
    return team.refusal(chain).map(why -> signed + ", which " + why);
  }

  /** Whether it is the manifest or a signature file. */
  private static boolean isSignature(String name) {
    return name.toUpperCase(Locale.ROOT)
        .matches("META-INF/(MANIFEST\\.MF|SIG-[^/]*|[^/]*\\.(SF|RSA|DSA|EC))");
  }

  private static CodeRefusedException refused(CodebaseUrl url, String why) {
    return new CodeRefusedException("codebase " + url.text() + " refused: " + why);
  }

  private static CodeRefusedException refused(CodebaseUrl url, String why, Exception cause) {
    return new CodeRefusedException("codebase " + url.text() + " refused: " + why, cause);
  }
}
