package org.dfra.cli.security;

import java.io.IOException;
import java.io.InputStream;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyXml;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.river.identity.TeamCredentials;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra security show}. */
@Command(
    name = "show",
    description = "Shows an identity, a bundle, an authority or a certificate.",
    footer = {
      "",
      "Shows whose it is, when it is valid, the SHA-256 fingerprints, and the numbers of the",
      "list of revoked certificates and of the policy. It shows no key."
    })
final class ShowCommand implements Callable<Integer> {

  private static final int ZIP = 'P' << 8 | 'K'; // the first two bytes

  @Parameters(
      paramLabel = "FILE",
      arity = "0..1",
      description =
          "A bundle, a certificate in PEM, the folder of an identity or of an authority (default:"
              + " this computer's identity).")
  private @Nullable Path file;

  @Option(
      names = "--passphrase-file",
      paramLabel = "FILE",
      description = "File whose first line is the bundle's passphrase (default: asks for it).")
  private @Nullable Path passphraseFile;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() throws Exception {
    answer.details(view(file == null ? state.folder().resolve(SecurityFiles.FOLDER) : file));
    return ExitCode.SUCCESS;
  }

  private Object view(Path shown) throws IdentityException, IOException {
    boolean isAuthority =
        Files.exists(shown.resolve(SecurityFiles.AUTHORITY))
            && !Files.exists(shown.resolve(SecurityFiles.IDENTITY));
    if (isAuthority) {
      return authority(shown);
    } else if (Files.isDirectory(shown) || file == null) {
      TeamCredentials own = IdentityFolder.load(shown);
      return MemberView.of(own, policy(shown), StoredDelegations.list(shown, own), Instant.now());
    } else if (!Files.exists(shown)) {
      throw new IdentityException(
          "there is no file " + shown + "; name a bundle, a certificate or a folder");
    } else if (isZip(shown)) {
      Bundle bundle = Bundle.read(shown);
      String passphrase =
          PassphraseSource.read(passphraseFile, "passphrase of " + shown, "--passphrase-file");
      return MemberView.of(
          VerifiedBundle.open(bundle, passphrase, shown.toString()), Instant.now());
    }
    return CertificateView.of(certificate(shown), shown.toString());
  }

  private static CertificateView authority(Path folder) throws IdentityException, IOException {
    Path file = folder.resolve(SecurityFiles.AUTHORITY);
    X509Certificate authority =
        TeamCertificates.authority(Files.readAllBytes(file), file.toString());
    Path list = folder.resolve(SecurityFiles.REVOKED);
    Optional<BigInteger> number =
        Files.exists(list)
            ? SignedFiles.number(
                SignedFiles.revocations(Files.readAllBytes(list), authority, list.toString()))
            : Optional.empty();
    return CertificateView.of(
        authority, file.toString(), number, policy(folder).map(Policy::version));
  }

  private static Optional<Policy> policy(Path folder) {
    Path policy = folder.resolve(SecurityFiles.POLICY);
    return Files.exists(policy)
        ? Optional.of(PolicyXml.read(policy, BundledPolicy.catalogue()))
        : Optional.empty();
  }

  private static boolean isZip(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return (in.read() << 8 | in.read()) == ZIP;
    }
  }

  private static X509Certificate certificate(Path file) throws IdentityException, IOException {
    try (InputStream in = Files.newInputStream(file)) {
      return (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(in);
    } catch (CertificateException e) {
      throw new IdentityException(
          file + " is neither a bundle nor a certificate (" + e.getMessage() + ")", e);
    }
  }
}
