/**
 * The RMI activation API for JDK 17 and later, which no longer include it.
 *
 * <p>Clients can call objects that are not running: an {@link java.rmi.activation.ActivationSystem}
 * stores their {@linkplain java.rmi.activation.ActivationDesc descriptors}, an {@link
 * java.rmi.activation.Activator} starts them on the first call, in the JVM of their {@linkplain
 * java.rmi.activation.ActivationGroup group}.
 *
 * <pre>
 *   client --ActivationID.activate--&gt; Activator ---ActivationInstantiator--&gt; ActivationGroup (JVM)
 *                                     ActivationSystem &lt;--ActivationMonitor--     |
 *                                     (the daemon)                              object
 * </pre>
 *
 * <p>Start at {@link java.rmi.activation.ActivationGroup} for the code inside a group's JVM, at
 * {@link java.rmi.activation.ActivationSystem} for registration, and at {@link
 * java.rmi.activation.ActivationID} for the client's reference. Apache River's JERI needs this
 * package at class initialisation even if no object is ever activated.
 *
 * <p>Written from the public specification of Java SE 16: the same names, signatures,
 * serialVersionUIDs and serial forms, so peers on older releases interoperate. The classes are not
 * marked deprecated here. Only the boot loader may define a package named {@code java.*}: put the
 * jar there with {@code -Xbootclasspath/a:} or with the agent {@code
 * org.dfra.activation.BootPathAgent}. No security manager is consulted anywhere.
 */
package java.rmi.activation;
