// dfra-api needs the JDK only.
