/**
 * What tests of a module stand on, also of modules that are not DFRA's own.
 *
 * <pre>
 *   test --&gt; JiniModuleDirectory --&gt; EmbeddedReggie &lt;--joins-- ServedModule (server, proxy, driver)
 *                    all of it in the test's own virtual machine
 * </pre>
 *
 * <p>Enter at {@link org.dfra.testing.EmbeddedReggie}; {@code
 * docs/how-to/test-with-embedded-reggie.md} has a whole example.
 */
package org.dfra.testing;
