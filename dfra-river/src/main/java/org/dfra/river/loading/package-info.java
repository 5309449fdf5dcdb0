/**
 * Trusted code: how classes that a virtual machine lacks come to it, and which it takes.
 *
 * <pre>
 *   robot's -dl jars --&gt; ClassServer --httpmd://host:port/x.jar;sha-256=...--&gt; annotation in streams
 *                                                                                 |
 *      local class path first &lt;-- VerifiedClassProvider (RMIClassLoaderSpi) &lt;----/
 *                                     | CodeTrust: digest pinned, vouched for, or jar signed?
 *                                     v
 *               JarDownload --bytes--&gt; VerifiedJar --the same bytes--&gt; VerifiedLoader
 * </pre>
 *
 * <p>There is no sandbox: code that is loaded may do what this virtual machine may do. Hence
 * nothing is loaded that is not trusted, and a digest in a URL is no trust, since it comes from
 * whom the URL comes from.
 *
 * <p>Enter at {@link org.dfra.river.loading.TrustedCode} as a main, at {@link
 * org.dfra.river.loading.ClassServer} to serve jars.
 */
@NullMarked
package org.dfra.river.loading;

import org.jspecify.annotations.NullMarked;
